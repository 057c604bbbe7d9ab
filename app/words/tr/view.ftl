view-menu = Görünüm
    .hint = Görünüm: koyu, projeksiyon, yardım ve daha fazlası
view-help = softrod nasıl kullanılır
view-help-drag = İstediğin kütleyi <b>sürükle</b>. Sabitlenmiş olanlar bıraktığın yerde kalır, serbest olanlar düşer. Kâğıdı kaydırmak için sürükle, yakınlaştırmak için tekerleği çevir veya iki parmağını kullan.
view-help-change = “Dene” sekmesinde sertliği, sönümü, uzunlukları ve açıları <b>değiştir</b> veya “Düzenle” ile kendi cismini çiz.
view-help-measure = Periyodun ve sönümün okunduğu grafiklerle, oklarla, cetvelle, açıölçerle ve kronometreyle <b>ölç</b>.
view-help-time = Cismin altındaki çubuk, hareketin istediğin anına geri gider. “Oynat”, çubuğun gösterdiği andan devam eder; geri gitmenden önce olanlar ince bir çizgi olarak kalır. Eklemini okumak için bir kütleye tıkla veya dokun.
